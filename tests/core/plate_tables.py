# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an independent implementation of the discrete Kirchhoff triangle gives, for nu = 0.3.

For the tests and for the validation page.
"""

#: Cells of a quarter plate: deflection of the centre, simply supported and clamped under an even load q
#: [q L^4 / D], then under a load P at the centre [P L^2 / D].
PLATES = {
    2: (0.00405587, 0.00154738, 0.0116879, 0.00585546),
    4: (0.00406485, 0.00134741, 0.0116343, 0.00570755),
    8: (0.00406367, 0.00128653, 0.0116139, 0.00564105),
    16: (0.00406277, 0.00127068, 0.0116053, 0.00562040),
}
#: Of one element with the corners (0, 0), (1, 0), (0, 1), other than the three zeros, in D.
EIGENVALUES = (0.3285165, 0.3765674, 0.5926962, 1.4688844, 8.0682365, 17.0900991)
