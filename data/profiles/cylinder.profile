# Fig. 2 (f): a cylinder.
units = mm
shape = cylinder
radius = 3
height = 10
