# Fig. 2 (f): a cylinder, as a path from the bottom of the axis to its top.
units = mm
start 0 -5
line 3 -5
line 3 5
line 0 5
