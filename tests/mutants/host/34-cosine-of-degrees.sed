# file: host/render/pack.cpp
# tests: gpu/answers_test.cpp
# test: Scenes/Answers.Hold/34_spot_cutoff
# Defect 34: the cone's half-angle is taken for radians.
s/0\.5 \* radians(light\.cutoff_deg)/0.5 * light.cutoff_deg/
