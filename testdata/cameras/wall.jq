# The scene whose picture fills a wall, from the lower left, lower right and upper left
# corner of the wall, and the eye, in world space.
# usage: jq -f wall.jq
def less(a; b): [a, b] | transpose | map(.[0] - .[1]);
def dot(a; b): [a, b] | transpose | map(.[0] * .[1]) | add;
def unit: (dot(.; .) | sqrt) as $n | map(. / $n);
.[3] as $eye | map(less(.; $eye)) as [$ll, $lr, $ul] |
less($lr; $ll) as $r | less($ul; $ll) as $u |
[$u[1]*$r[2] - $u[2]*$r[1], $u[2]*$r[0] - $u[0]*$r[2],
  $u[0]*$r[1] - $u[1]*$r[0]] as $gaze |
{
  convention: "gl", viewport: {width: 1600, height: 1200},
  camera: {eye: $eye, gaze: $gaze, up: $u},
  projection: {type: "persp", near: 0.1, far: 100, edges_at: dot($ll; $gaze | unit),
    left: dot($ll; $r | unit), right: dot($lr; $r | unit),
    bottom: dot($ll; $u | unit), top: dot($ul; $u | unit)}
}
