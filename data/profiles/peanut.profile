# Fig. 2 (k): a peanut from a Cassini oval, 10 mm long and 3.5 mm thick at its waist.
units = mm
shape = peanut
length = 10
waist = 3.5
