# The tablet of tablet.profile with its two edges rounded by band_radius / 30.
units = mm
shape = tablet
band_radius = 5.675
band_height = 4.0
cap_height = 1.23
edge_radius = 0.1891667
