# Fig. 2 (e): a superquadric (r/a)^8 + (z/c)^8 = 1, a flat cylinder with tight edges.
units = mm
shape = superquadric
a = 5
c = 2
exponent = 8
