# Fig. 2 (b): an oblate spheroid, flattened along its axis.
units = mm
shape = spheroid
a = 5          # equator
c = 2.5        # along the axis
