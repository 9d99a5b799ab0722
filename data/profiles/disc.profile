# Fig. 2 (g): a disc. Both ends of the path lie off the axis and are closed by flat faces.
units = mm
start 5 -1
line 5 1
