# Moves points of view space, x right, y down, z forward, as the lens of OpenCV's
# projectPoints does or, with back=1, back before the lens; nan where it shows none.
# usage: awk -v k='k1 k2 p1 p2 [k3 [k4 k5 k6]]' [-v back=1] -f lens.awk [FILE...]
BEGIN {
  n = split(k, c)
  if (n != 4 && n != 5 && n != 8) {
    print "lens.awk: a lens has 4, 5 or 8 coefficients, not " n > "/dev/stderr"
    exit 1
  }
}
function bend(x, y, r, m, e) { # false where the picture would fold
  r = x*x + y*y; m = 1 + r*(c[6] + r*(c[7] + r*c[8]))
  d = (1 + r*(c[1] + r*(c[2] + r*c[5]))) / m
  e = 2*(c[1] + r*(2*c[2] + 3*r*c[5]) - d*(c[6] + r*(2*c[7] + 3*r*c[8]))) / m
  u = x*d + 2*c[3]*x*y + c[4]*(r + 2*x*x); uu = d + e*x*x + 2*c[3]*y + 6*c[4]*x
  v = y*d + c[3]*(r + 2*y*y) + 2*c[4]*x*y; vv = d + e*y*y + 6*c[3]*y + 2*c[4]*x
  uv = e*x*y + 2*c[3]*x + 2*c[4]*y; s = uu*vv - uv*uv; return uu > 0 && s > 0
}
{
  ok = $3 + 0 > 0; if (ok) { X = $1 / $3; Y = $2 / $3 }
  for (i = 1; ok && !back && i <= 64; i++) ok = bend(X * i / 64, Y * i / 64)
  for (x = y = 0; ok && back && i <= 64; i++) if (ok = bend(x, y)) {
    g = X * (i < 32 ? i / 32 : 1) - u; h = Y * (i < 32 ? i / 32 : 1) - v
    x += (g*vv - h*uv) / s; y += (h*uu - g*uv) / s
  }
  if (ok && back) {
    ok = bend(x, y) && (u - X)^2 + (v - Y)^2 < 1e-24 * (1 + X*X + Y*Y); u = x; v = y
  }
  print ok ? sprintf("%.17g %.17g %s", u * $3, v * $3, $3) : "nan nan nan"
}
END { exit NR == 0 }
