# Fig. 2 (j): a spherocylinder (capsule): half a sphere, a cylinder, half a sphere.
units = mm
start 0 -5.5
arc 2.5 -3 radius 2.5
line 2.5 3
arc 0 5.5 radius 2.5
