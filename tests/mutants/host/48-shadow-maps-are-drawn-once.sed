# file: host/raster/shadow_pass.cpp
# tests: gpu/shadow_map_test.cpp
# test: ShadowMap.IsDrawnAnewWhenThingsMove
# Defect 48: the shadow map of the first picture stays.
s/^        drawn_ = false;$/        drawn_ = drawn_ || false;/
