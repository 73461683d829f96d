# file: trace/breadth_first.glsl
# answer: 18-two-glass-balls-behind-each-other
# Defect 19: the queue has 4 places, and more are written: what lies beyond is lost, or worse. (Two
# more than the budget, as it was, are never read again: nothing shows on a driver that drops them.)
s/Path queue\[QUEUE_SLOTS\]/Path queue[4]/
