# Fig. 2 (l): a red blood cell by the formula of Evans & Fung (1972), 7.82 um across in nature, here
# a thousand times larger.
units = mm
shape = red_blood_cell
diameter = 7.82
