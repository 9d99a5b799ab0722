# Fig. 2 (j): a spherocylinder (capsule): half a sphere, a cylinder, half a sphere.
units = mm
shape = spherocylinder
radius = 2.5
cylinder_height = 6
