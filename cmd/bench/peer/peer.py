# SPDX-License-Identifier: MIT
# Multiplies points by a 4x4 matrix for row vectors, and divides by w, in blocks
# that stay in the cache.
# usage: python3 peer.py MATRIX text|f64 POINTS
import sys

import numpy

matrix = numpy.loadtxt(sys.argv[1])
text = sys.argv[2] == "text"
read = numpy.loadtxt if text else numpy.fromfile
points = read(sys.argv[3]).reshape(-1, 3)
for i in range(0, len(points), 4096):
    image = points[i:i + 4096] @ matrix[:3]
    image += matrix[3]
    image = image[:, :3] / image[:, 3:]
    if text:
        numpy.savetxt(sys.stdout, image, fmt="%.17g")
    else:
        image.tofile(sys.stdout)
