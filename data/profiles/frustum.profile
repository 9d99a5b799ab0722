# Fig. 2 (i): a conical frustum, as a table of the points r z of its outline.
units = mm
r   z
0   -3
4   -3
2    3
0    3
