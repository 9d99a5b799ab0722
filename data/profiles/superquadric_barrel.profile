# Fig. 2 (d): a superquadric (r/a)^4 + (z/c)^4 = 1, a cylinder with soft edges.
units = mm
shape = superquadric
a = 3
c = 5
exponent = 4
