# Fig. 2 (a) of the SR-DEM paper: a sphere.
units = mm
shape = sphere
radius = 5
