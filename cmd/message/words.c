/* SPDX-License-Identifier: MIT */
#include "words.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

enum {
	CALL = WORD_COMMAND | WORD_OPTION,
	/* The last word of the hint is also meant where it is a possible value. */
	VALUE = CALL | WORD_VALUE,
	REMARK = WORD_COMMAND | WORD_OPTION | WORD_MEMBER,
};

/* Words of other programs, with blanks between them, where they stand, and the hint
 * (word_hint) for each of these words. Names that other programs have for members are
 * in the tables of cmd/scene. */
/* clang-format off */
static const struct {
	unsigned places; /* as bits of enum word_place */
	const char *words, *hint;
} word_rows[] = {
	{ VALUE, "unproject backproject", "project --from device --to world" },
	{ CALL, "screen2world screentoworld", "project --from device --to world" },
	{ REMARK, "inverse invert",
	    ": the way back is project --from device --to world; of lookat project -m "
	    "--from view --to world; in 2D d2w, n2w or d2n" },
	{ VALUE, "ray raycast", "project --ray" },
	{ CALL, "transform points world2screen worldtoscreen", "project" },
	{ VALUE, "mvp matrix", "project -m --to clip" },
	{ VALUE, "pose", "project -m --from view --to world" },
	{ VALUE, "viewport", "project --from ndc --to device" },
	{ CALL, "camera view lookat", "lookat" },
	{ VALUE, "camera", "project --to view" },
	{ WORD_VALUE, "eye", "--to view" },
	{ VALUE, "object local", "--from model" },
	{ VALUE, "cv", "--convention opencv" },
	{ WORD_COMMAND, "version", ": 'projcalc --version' prints it" },
	{ CALL, "perspective projection", "persp" },
	{ REMARK, "frustum",
	    ": persp makes one of its left, right, bottom, top, near and far, and inspect "
	    "describes one" },
	{ CALL, "orthographic", "ortho" },
	{ CALL, "cavalier cabinet", "oblique" },
	{ WORD_VALUE, "cavalier cabinet",
	    ": it is a \"kind\" of \"type\": \"oblique\"; receding lines have the "
	    "\"direction\" in the picture" },
	{ CALL, "transpose columnmajor rowmajor columnvectors",
	    ": d3d is for row vectors, the other conventions are for column vectors; of "
	    "its own, \"convention\": {\"vectors\": \"column\"} beside \"projection\" or "
	    "\"camera\"" },
	{ CALL, "window", "w2n" },
	{ CALL, "w2v window2viewport windowtoviewport", "w2d" },
	{ CALL, "device", "n2d" },
	{ CALL, "bounds zoom extent", "fit" },
	{ CALL, "info decompose planes frustumplanes clipplanes rq", "inspect" },
	{ CALL, "click", "pick" },
	{ CALL, "explain", "trace" },
	{ CALL, "usage man", "help" },
	{ CALL, "homography", "project -m -c opencv --plane 0,0,1,0" },
	{ CALL, "vanishing vanishingpoint vanishingpoints", "inspect" },
	{ CALL, "triangulate", "project --ray" },
	{ CALL, "rectify",
	    ": give the rectified P as \"intrinsics\"; 'man projcalc-scene' reads it of ROS" },
	{ CALL, "solvepnp pnp calibrate",
	    ": poses are not estimated; solvePnP's rvec and tvec are \"rvec\" and "
	    "\"translation\" of \"camera\"" },
	{ CALL, "render draw plot",
	    ": 'A wireframe' in 'man projcalc-scene' makes lines for gnuplot" },

	{ CALL, "format", ": -i names the format of POINTS, -o that of the output" },
	{ VALUE, "json", "--output json" },
	{ VALUE, "csv", "--input csv" },
	{ CALL, "delimiter", "--separator" },
	{ CALL, "cols", "--columns" },
	{ CALL, "space", "--to" },
	{ CALL, "threads", "--jobs" },
	{ CALL, "round places", "--decimals" },
	{ CALL, "epsilon", "--tolerance" },
	{ CALL, "cull", "--visible" },
	{ CALL, "verbose", "--progress" },
	{ CALL, "silent", "--quiet" },
	{ VALUE, "convert opengl", "--convention gl" },
	{ VALUE, "directx direct3d", "--convention d3d" },
	{ CALL, "d3d gl vulkan webgpu opencv", "--convention *" },
	{ WORD_OPTION, "pixel pixels",
	    ": pixels are POINTS, as '[320,240]', of pick --at 320,240; --to device prints "
	    "them" },
	{ VALUE, "pixel pixels screen image", "--to device" },
	{ VALUE, "texture uv",
	    ": it is \"device\" with \"viewport\": {\"width\": 1, \"height\": 1}" },
	{ CALL, "world view ndc device", "--to *" },
	{ VALUE, "float", "--precision single" },

	{ WORD_COMMAND, "depth",
	    ": project --to view prints z of points, and inspect the steps of depth" },
	{ WORD_OPTION, "depth distance", "--to view, or \"viewport\": {\"depth\": \"distance\"}" },
	{ REMARK, "stdin", ": standard input is - in place of PARAMS or POINTS" },
	{ REMARK, "clip", ": project --visible leaves out points that are outside; project "
	    "--to clip prints x y z w" },
	{ REMARK, "jitter",
	    ": 'A jitter of half a pixel' in 'man projcalc-scene' moves the edges" },
	{ REMARK, "infinite infinitefar", ": write \"far\": \"infinity\"" },
	{ CALL, "na skip ignoreerrors",
	    ": NA and nan print nan, and --keep-going passes bad lines" },
	{ CALL, "ground", ": project --plane 0,1,0,0 is the ground y = 0, --plane 0,0,1,0 z = 0" },
	{ REMARK, "crs epsg srs lat lon alt latitude longitude altitude",
	    ": coordinates are lengths; of degrees cs2cs makes metres first" },
	{ REMARK, "P0 P1 P2 P3 prect00 prect01 prect02 prect03",
	    ": P is \"intrinsics\" of \"projection\", 3 rows of 4 numbers, with \"type\": "
	    "\"persp\", beside \"viewport\" and \"convention\": \"opencv\"" },
	{ REMARK, "r0rect rrect rrect00 tr trvelotocam trvelocam",
	    ": steps chain them: \"world\": [{\"matrix\": Tr}, {\"matrix\": [R0|0]}]; "
	    "'The lidar of KITTI' in 'man projcalc-scene'" },
	{ REMARK, "cameraintrinsic",
	    ": it is \"intrinsics\" of \"projection\"; the camera's frame is \"pose\" of "
	    "\"camera\", as steps [{\"quaternion_wxyz\": rotation}, {\"translate\": "
	    "translation}]; 'Sensors of nuScenes' in 'man projcalc-scene'" },
	{ REMARK, "distortion undistort distort distortioncoefficients distortioncoeffs "
	    "distortionmodel distortionparams radialdistortion tangentialdistortion "
	    "distcoeffs distcoef distcoeff dist fisheye d k1 k2 k3 k4 k5 k6 p1 p2",
	    ": lenses are not modelled; 'Points through a lens' in 'man projcalc-scene' "
	    "bends points by awk" },
	{ REMARK, "focal focallength focallengthmm lens sensorwidth sensorheight sensorsize "
	    "filmgauge f",
	    ": in mm give the sensor's \"width\" and \"height\", and \"edges_at\", the "
	    "focal length; in pixels \"intrinsics\": [fx, fy, cx, cy]" },
	{ WORD_VALUE, "fisheye",
	    ": lenses are not modelled; 'Points through a lens' in 'man projcalc-scene' "
	    "bends points by awk" },
	{ VALUE, "isometric dimetric trimetric axonometric",
	    ": it is \"ortho\" of a camera askew to the axes, such as \"gaze\": "
	    "[-1,-1,-1]" },
	{ VALUE, "lh lefthanded",
	    ": the \"handedness\" is \"left\", as that of \"d3d\"" },
	{ VALUE, "rh righthanded",
	    ": the \"handedness\" is \"right\", as that of \"gl\", \"vulkan\", \"webgpu\" "
	    "and \"opencv\"" },
	{ WORD_VALUE, "contain letterbox cover crop",
	    ": \"grow\" contains the window, and \"shrink\" covers the device" },
	{ WORD_VALUE, "0 1 2 3 4 5 6 7 8 9 10 12",
	    ": of decimals it is --decimals, of digits --digits" },
	{ WORD_MEMBER, "dfov diagonalfov fovd",
	    ": of the diagonal; \"fovy\" is 2 atan(tan(dfov / 2) height / hypot(width, "
	    "height))" },
	{ REMARK, "depthscale depthfactor",
	    ": scale the depth before: awk '{$3 *= 0.001} 1'" },
	{ REMARK, "size imagesize imageresolution windowsize resolution",
	    ": give \"width\" and \"height\", of a picture in \"viewport\"" },
	{ REMARK, "euler rotationeuler eulerangles yaw pitch heading omega phi kappa azimuth",
	    ": angles are steps, as \"pose\" of \"camera\", in place of \"eye\": "
	    "[{\"rotate_x\": 10}, {\"rotate_y\": 30}, {\"translate\": [0,0,5]}], beside a "
	    "\"convention\"; units, orders and signs differ, see 'Yaw, pitch and roll' in "
	    "'man projcalc-scene'" },
	{ WORD_MEMBER, "right top xmax ymax",
	    ": edges are of \"projection\" or \"window\"; a viewport and a device have "
	    "\"width\" (right - left) and \"height\" (top - bottom)" },
	{ WORD_MEMBER, "R T t",
	    ": world to view they are \"matrix\" of \"camera\", [R|t] as 3 rows of 4" },
	{ WORD_MEMBER, "H homography",
	    ": [[a,b,c],[d,e,f],[g,h,i]] is \"projection\": {\"type\": \"matrix\", \"matrix\": "
	    "[[a,b,0,c],[d,e,0,f],[0,0,1,0],[g,h,0,i]]} in \"convention\": {\"vectors\": "
	    "\"column\"}; of a camera and a plane 'project -m -c opencv --plane 0,0,1,0' makes "
	    "one" },
	{ WORD_MEMBER, "header binningx binningy roi",
	    ": is it ROS's? 'A CameraInfo of ROS' in 'man projcalc-scene' reads one, 'Frames "
	    "of ROS and tf2' a transform" },
	{ WORD_MEMBER, "metadata object",
	    ": is it three.js's? a camera's \"matrix\" is \"pose\" of \"camera\", with "
	    "\"convention\": \"webgpu\", its \"fov\" is \"fovy\"" },
	{ WORD_MEMBER, "token sensortoken sampletoken calibratedsensortoken egoposetoken",
	    ": is it nuScenes's? 'Sensors of nuScenes' in 'man projcalc-scene' reads one" },
	{ WORD_MEMBER, "translation",
	    ": where the camera stands it is \"eye\" of \"camera\", the t of [R|t] is "
	    "\"translation\" there; 'Sensors of nuScenes' in 'man projcalc-scene' chains "
	    "frames" },
	{ WORD_MEMBER, "quaternion quat rotation localrotation",
	    ": x, y, z, w from view to world it is \"orientation\" of \"camera\"; to turn "
	    "the model, \"world\": [{\"quaternion\": q}]; with w first \"quaternion_wxyz\"" },
	{ REMARK, "qvec qw quaternionwxyz",
	    ": world to view, w first, it is \"matrix\": [{\"quaternion_wxyz\": q}, "
	    "{\"translate\": t}] of \"camera\"; view to world it is \"pose\"" },
	{ WORD_MEMBER, "shiftx shifty lensshift",
	    ": give left, right, bottom and top, as 'A camera of Blender' in "
	    "'man projcalc-scene' does" },
	{ WORD_MEMBER, "projectionmatrix",
	    ": view to clip it is \"matrix\" in \"projection\", with \"type\": \"matrix\"; "
	    "the 3x4 P of ROS is \"intrinsics\"" },
	{ WORD_MEMBER, "mvp vp viewproj viewprojection viewprojectionmatrix",
	    ": without a camera it is \"matrix\" in \"projection\", with \"type\": "
	    "\"matrix\"" },
	{ REMARK, "params cameramodel",
	    ": \"intrinsics\" are [fx, fy, cx, cy]; 'A model of COLMAP' in "
	    "'man projcalc-scene' finds them" },
	{ WORD_MEMBER, "asset scenes nodes accessors bufferviews cameras",
	    ": is it glTF? 'A camera of glTF' in 'man projcalc-scene' reads one; of other lists "
	    "jq -c '.cameras[]' makes scenes for --scenes" },
	{ WORD_MEMBER, "perspective orthographic",
	    ": it is the \"type\" of \"projection\", \"persp\" or \"ortho\"; 'A camera of "
	    "glTF' in 'man projcalc-scene' reads glTF's" },
	{ REMARK, "eyeseparation ipd interocular stereo convergence",
	    ": PICTURES IN PAIRS AND PARTS of 'man projcalc-scene' draws pairs" },
	{ WORD_MEMBER, "frames filepath aabbscale",
	    ": is it NeRF's? 'A frame of NeRF' in 'man projcalc-scene' reads one" },
	{ WORD_MEMBER, "childframeid transforms",
	    ": is it of tf2? 'Frames of ROS and tf2' in 'man projcalc-scene' chains them" },
	{ WORD_MEMBER, "origin",
	    ": it belongs in \"device\" or, of a viewport, in \"convention\"; \"webgpu\" is "
	    "\"gl\" with y from the top, and depth from 0" },
	{ REMARK, "zoom",
	    ": only a window has it; in 3D divide \"width\" and \"height\" of \"ortho\", or "
	    "give a smaller \"fovy\"" },
	{ REMARK, "scale",
	    ": only a viewport has it; in 3D \"world\": [{\"scale\": 2}] scales points" },
	{ REMARK, "vrp prp",
	    ": \"eye\" is the centre of projection; where PRP is 0,0,d of VRP's axes, it is "
	    "VRP + d VPN for a VPN of length 1" },
	{ REMARK, "vpn", ": VPN points to the eye; \"gaze\" is its opposite" },
	{ REMARK, "dop",
	    ": \"gaze\" is DOP in \"ortho\"; a DOP askew to the picture is \"oblique\", with "
	    "\"angle\" and \"direction\"" },
	{ REMARK, "features geometry geometries coordinates featurecollection feature",
	    ": is it GeoJSON? jq -c '..|.coordinates?|arrays|..|arrays|"
	    "select(.[0]|numbers)' makes lines of points for -i json" },

	{ WORD_JSON, "nan none undefined",
	    ": a point may have null; in a scene write a number, or leave the member out" },
	{ WORD_JSON, "imagewidth imageheight cameramatrix header",
	    ": is it ROS's? 'A CameraInfo of ROS' in 'man projcalc-scene' reads YAML" },
	{ WORD_JSON, "P0 P1 P2 P3 Tr calibtime",
	    ": is it KITTI's? 'The lidar of KITTI' in 'man projcalc-scene' reads calib.txt" },
	{ WORD_JSON, "infinity inf",
	    ": write \"infinity\" for far, else a number up to 1e150; a point "
	    "may have null" },
	{ WORD_JSON, "True False", ": JSON has true and false" },

	{ VALUE, "threejs three.js glm directxmath",
	    ": elements of three.js and GLM are \"gl\", of DirectXMath \"d3d\"; 'Matrices of "
	    "GLM, DirectXMath and three.js' in 'man projcalc-scene'" },
	{ VALUE, "unity unity3d",
	    ": its transforms, position and rotation, are \"d3d\", the matrices of its cameras "
	    "\"gl\", as 'A camera of Unity' in 'man projcalc-scene' reads them" },
	{ VALUE, "unreal ue4 ue5 hlsl metal",
	    ": it is \"d3d\" if view space is left-handed, as Unreal's, else \"webgpu\"; "
	    "'projcalc help convention' has their axes" },
	{ VALUE, "glsl", ": it is \"gl\", or \"vulkan\" if Vulkan draws" },
	{ VALUE, "blender bpy",
	    ": it is \"webgpu\"; 'A camera of Blender' in 'man projcalc-scene' reads one" },
	{ VALUE, "openxr",
	    ": it is \"vulkan\"; 'A field of view of OpenXR' in 'man projcalc-scene'" },
	{ VALUE, "colmap",
	    ": it is \"opencv\"; 'A model of COLMAP' in 'man projcalc-scene' reads one" },
	{ VALUE, "nerf nerfstudio instantngp",
	    ": it is \"webgpu\"; 'A frame of NeRF' in 'man projcalc-scene' reads one" },
	{ VALUE, "ros ros2",
	    ": it is \"opencv\"; 'A CameraInfo of ROS' in 'man projcalc-scene' reads one" },
	{ VALUE, "xyz txt", "--input text" },
	{ VALUE, "obj", ": grep '^v ' keeps its vertices, for --columns 2,3,4" },
	{ VALUE, "ply pcd", ": of its ASCII form cut off the header, for -i text" },
	{ VALUE, "bin binary float32 float64 double <f8 <f4 <f8x3 <f4x3 f4 f8 kitti npy raw "
	    "numpy",
	    ": -i f32x4 reads four floats a point (KITTI's .bin), -i f32 three, -i f64 three "
	    "doubles, and -o text prints text; of a .npy it tells what to cut off" },
};
/* clang-format on */

enum { WORD_ROWS = sizeof word_rows / sizeof *word_rows };

const char *word_hint(const char *word, enum word_place place, char first)
{
	for (int i = 0; i < WORD_ROWS; i++)
		if ((word_rows[i].places & place) != 0 &&
		    (first == '\0' || *word_rows[i].hint == first) &&
		    word_is_one_of(word, word_rows[i].words))
			return word_rows[i].hint;
	return NULL;
}

/* Returns whether at most n edits, which word_closeness defines, make b of a. */
static bool edits_reach(const char *a, const char *b, int n)
{
	for (; *a != '\0' && strncasecmp(a, b, 1) == 0; a++)
		b++;
	if (n == 0 || (*a == '\0' && *b == '\0'))
		return *a == *b;
	if ((*a != '\0' && edits_reach(a + 1, b, n - 1)) ||
	    (*b != '\0' && edits_reach(a, b + 1, n - 1)))
		return true;
	return *a != '\0' && *b != '\0' &&
	    (edits_reach(a + 1, b + 1, n - 1) ||
		(strncasecmp(a, b + 1, 1) == 0 && strncasecmp(a + 1, b, 1) == 0 &&
		    edits_reach(a + 2, b + 2, n - 1)));
}

int word_closeness(const char *word, const char *name)
{
	const size_t n = strlen(word), m = strlen(name), least = n < m ? n : m;
	const int most = n < 2 ? 0 : n < 6 ? 1 : n < 9 ? 2 : 3;

	for (int edits = 0; edits <= most; edits++)
		if (edits_reach(word, name, edits))
			return WORD_EDITED + 3 - edits;
	return least > 2 && strncasecmp(word, name, least) == 0 ? WORD_BEGINS : 0;
}

void word_offer(struct word_guess *g, int closeness, const char *format, ...)
{
	va_list args;

	if (closeness <= g->closeness)
		return;
	va_start(args, format);
	vsnprintf(g->remedy, sizeof g->remedy, format, args);
	va_end(args);
	g->closeness = closeness;
}

void word_offer_list(struct word_guess *g, const char *const *words, const char *format)
{
	const char *hint = word_hint(g->word, WORD_VALUE, '\0');

	if (hint != NULL && *hint == ':')
		word_offer(g, WORD_KNOWN, "%s", hint + 2);
	for (; *words != NULL; words++)
		word_offer(g,
		    hint != NULL && strcmp(strrchr(hint, ' ') + 1, *words) == 0 ?
			WORD_KNOWN :
			word_closeness(g->word, *words),
		    format, *words);
}

bool word_is_one_of(const char *word, const char *words)
{
	while (words != NULL && *words != '\0') {
		const char *s = word + strspn(word, "_-");

		while (*words > ' ' &&
		    (*words == '_' || *s == *words ||
			tolower((unsigned char)*s) == *words)) {
			s += *words++ != '_';
			s += strspn(s, "_-");
		}
		if (*s == '\0' && *words <= ' ')
			return true;
		words += strcspn(words, " ");
		words += *words == ' ';
	}
	return false;
}

const char *words_join(char out[LIST_ROOM], const char *const *words,
    const char *before_last, const char *quote)
{
	size_t at = 0;

	*out = '\0';
	for (int i = 0; words[i] != NULL && at < LIST_ROOM; i++)
		at += (size_t)snprintf(out + at, LIST_ROOM - at, "%s%s%s%s",
		    i == 0                   ? "" :
			words[i + 1] == NULL ? before_last :
					       ", ",
		    quote, words[i], quote);
	return out;
}
