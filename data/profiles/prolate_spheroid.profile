# Fig. 2 (c): a prolate spheroid. The papers' two-particle collision uses this one.
units = mm
shape = spheroid
a = 2.5
c = 5
