# Fig. 2 (h): the bi-convex tablet of Kodam et al., two spherical caps on a cylindrical band.
units = mm
shape = tablet
band_radius = 5.675
band_height = 4.0
cap_height = 1.23
