# Points through a 4x4 matrix for row vectors, divided.
# usage: python3 peer.py MATRIX POINTS
import sys

import numpy

matrix = numpy.loadtxt(sys.argv[1])
points = numpy.loadtxt(sys.argv[2])
image = numpy.column_stack((points, numpy.ones(len(points)))) @ matrix
numpy.savetxt(sys.stdout, image[:, :3] / image[:, 3:], fmt="%.17g")
