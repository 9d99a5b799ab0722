# The candy of the packing experiments of Gao et al., an oblate spheroid.
units = mm
shape = spheroid
a = 6.585
c = 3.395
