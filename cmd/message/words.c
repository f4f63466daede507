/* SPDX-License-Identifier: MIT */
#include "words.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

enum {
	CALL = WORD_COMMAND | WORD_OPTION,
	ARGUMENT = WORD_OPTION | WORD_VALUE,
	SETTING = WORD_OPTION | WORD_MEMBER,
};

/* Words of other programs. A remark says only what is certain wherever the word may
 * stand. synonyms_test types what it says: calls and titles in ', options, objects as
 * JSON, members as "name" of "object", and other words in " in place of the word. */
static const struct remark remarks[] = {
	/* commands */
	{ CALL, "unproject backproject screen2world screentoworld inverse invert", NULL,
	    "'projcalc project --from device --to world' leads back" },
	{ CALL, "raycast triangulate", NULL, "'projcalc project --ray' prints rays" },
	{ WORD_COMMAND, "ray", NULL, "'projcalc project --ray' prints rays" },
	{ CALL, "transform world2screen worldtoscreen", NULL,
	    "'projcalc project' maps points" },
	{ CALL, "mvp", NULL, "'projcalc project -m --to clip' prints the matrix" },
	{ WORD_COMMAND, "matrix", NULL,
	    "'projcalc project -m --to clip' prints a matrix" },
	{ WORD_COMMAND, "pose", NULL,
	    "'projcalc project -m --from view --to world' prints it" },
	{ WORD_COMMAND, "camera view", NULL,
	    "'projcalc lookat' prints the matrix of a camera" },
	{ WORD_COMMAND, "frustum pinhole", NULL,
	    "'projcalc persp' prints the matrix of a frustum" },
	{ WORD_COMMAND | WORD_VALUE, "cavalier cabinet military",
	    "kind projection oblique",
	    "it is a \"kind\" of \"projection\" of type \"oblique\"" },
	{ CALL | WORD_VALUE, "isometric dimetric trimetric axonometric",
	    "projection ortho camera eye gaze",
	    "it is {\"projection\": {\"type\": \"ortho\"}} with a gaze askew to the "
	    "axes, as {\"camera\": {\"eye\": [9,9,9], \"gaze\": [-1,-1,-1]}}" },
	{ WORD_COMMAND, "window", NULL,
	    "'projcalc w2n' prints the matrix of a window" },
	{ WORD_COMMAND, "device", NULL,
	    "'projcalc n2d' prints the matrix of a device" },
	{ WORD_COMMAND, "viewport", NULL,
	    "'projcalc project --from ndc --to device' maps to it" },
	{ WORD_COMMAND, "w2v window2viewport windowtoviewport", NULL,
	    "'projcalc w2d' maps a window to a device" },
	{ WORD_COMMAND, "bounds zoom extent", NULL,
	    "'projcalc fit' fits a scene to bounds" },
	{ CALL,
	    "info decompose planes frustumplanes clipplanes rq vanishing "
	    "vanishingpoint vanishingpoints",
	    NULL, "'projcalc inspect' finds it" },
	{ CALL, "click", NULL, "'projcalc pick' finds the points" },
	{ WORD_COMMAND, "step steps", NULL,
	    "'lists of steps' in 'man projcalc-scene' has them" },
	{ WORD_COMMAND, "space spaces", NULL, "'SPACES' in 'man projcalc' has them" },
	{ CALL, "explain", NULL, "'projcalc trace' shows each step" },
	{ CALL, "usage man manual", NULL, "'projcalc help' prints the usage" },
	{ WORD_COMMAND, "depth", NULL,
	    "'projcalc project --to view' prints z, 'projcalc inspect' the steps of "
	    "depth" },
	{ CALL | WORD_MEMBER, "homography", NULL,
	    "'projcalc project -m -c opencv --plane 0,0,1,0' prints that of a plane" },
	{ CALL, "solvepnp pnp calibrate", NULL,
	    "poses are not estimated; those of solvePnP are \"rvec\" and "
	    "\"translation\" of \"camera\"" },
	{ CALL, "rectify", NULL,
	    "the rectified P is \"intrinsics\" of \"projection\"" },
	{ CALL, "stereo", NULL,
	    "'PICTURES IN PAIRS AND PARTS' in 'man projcalc-recipes' has pairs" },

	/* options and their arguments */
	{ WORD_OPTION, "format json csv tsv", NULL,
	    "formats are named as in -i csv -o json" },
	{ WORD_OPTION, "delimiter delim", NULL,
	    "--separator ';' is between fields of csv" },
	{ WORD_OPTION, "cols fields", NULL,
	    "--columns 1,2,3 says where coordinates are" },
	{ WORD_OPTION, "space world view ndc device model", NULL,
	    "spaces are named as in --from world --to view" },
	{ WORD_OPTION, "d3d gl vulkan webgpu opencv opengl directx direct3d", NULL,
	    "conventions are named as in -c gl" },
	{ WORD_OPTION, "threads workers", NULL, "--jobs 2 uses two threads" },
	{ WORD_OPTION, "round places", NULL, "--decimals 2 rounds" },
	{ WORD_OPTION, "epsilon eps", NULL,
	    "'projcalc inspect --tolerance 1' takes an error" },
	{ WORD_OPTION, "cull", NULL, "--visible leaves out points that are outside" },
	{ WORD_OPTION, "clip", NULL,
	    "--visible leaves out points that are outside, --to clip prints x y z w" },
	{ WORD_OPTION, "outputfile outfile save", NULL,
	    "--output json names a format, > writes a file" },
	{ WORD_OPTION, "verbose", NULL, "--progress reports how many lines are done" },
	{ WORD_OPTION, "silent", NULL, "--quiet leaves out notes" },
	{ WORD_OPTION, "depth distance", NULL,
	    "--to view prints z, {\"viewport\": {\"depth\": \"distance\"}} the "
	    "distance" },
	{ WORD_OPTION, "stdin", NULL, "'projcalc inspect -' reads standard input" },
	{ WORD_OPTION, "na skip ignoreerrors", NULL, "--keep-going passes bad lines" },
	{ WORD_OPTION, "ground", NULL, "--plane 0,1,0,0 is the ground y = 0" },
	{ WORD_OPTION, "float", NULL,
	    "-p single computes in floats, -i f32 reads them" },
	{ WORD_VALUE, "float", "single f32",
	    "a precision is -p single, a format -i f32" },
	{ ARGUMENT, "pixel pixels screen image", "device world",
	    "--to device prints pixels, --from device --to world reads them" },
	{ ARGUMENT, "texture uv texcoord", "viewport width height device",
	    "it is --to device with {\"viewport\": {\"width\": 1, \"height\": 1}}" },
	{ WORD_VALUE, "camera", "view", "the camera's space is \"view\"" },
	{ WORD_VALUE, "local", "model", "the model's space is \"model\"" },
	{ WORD_VALUE, "xyz txt pts", "text", "-i text reads it" },
	{ WORD_VALUE,
	    "bin binary float32 float64 <f4 <f8 <f4x3 <f8x3 f4 f8 kitti raw double",
	    "f32x4 f32 f64",
	    "-i f32x4 reads four floats a point, -i f32 three, -i f64 three doubles" },

	/* conventions, and other words of scenes */
	{ WORD_VALUE, "threejs three.js glm", "gl",
	    "its matrices are those of \"gl\"" },
	{ WORD_VALUE, "directxmath", "d3d", "its matrices are those of \"d3d\"" },
	{ WORD_VALUE, "unity unity3d", "d3d gl",
	    "its transforms are \"d3d\", the matrices of its cameras \"gl\"" },
	{ WORD_VALUE, "unreal ue4 ue5", "d3d",
	    "its view space is left-handed, as that of \"d3d\"" },
	{ WORD_VALUE, "metal hlsl", "d3d webgpu",
	    "it is \"d3d\" if view space is left-handed, else \"webgpu\"" },
	{ WORD_VALUE, "glsl openxr", "gl vulkan",
	    "it is \"gl\" where OpenGL draws, and \"vulkan\" where Vulkan does" },
	{ WORD_VALUE, "blender bpy nerf nerfstudio instantngp arkit", "webgpu",
	    "its cameras look backward along z with y up, as those of \"webgpu\"" },
	{ WORD_VALUE, "colmap ros ros2 opensfm", "opencv",
	    "its cameras look along z with y down, as those of \"opencv\"" },
	{ WORD_VALUE, "lh lefthanded d3dlh", "d3d convention handedness left",
	    "it is {\"convention\": {\"handedness\": \"left\"}}, with the rest as "
	    "\"d3d\" has it" },
	{ WORD_VALUE, "rh righthanded d3drh", "d3d convention handedness right",
	    "it is {\"convention\": {\"handedness\": \"right\"}}, with the rest as "
	    "\"d3d\" has it" },
	{ WORD_VALUE, "contain letterbox cover crop", "grow shrink",
	    "\"grow\" contains the window, \"shrink\" covers the device" },
	{ CALL | WORD_MEMBER, "transpose columnmajor rowmajor columnvectors rowvectors",
	    "convention vectors column",
	    "it is {\"convention\": {\"vectors\": \"column\"}} for column vectors, M "
	    "p" },
	{ SETTING, "radians degrees unit units angles angleunits", "angle_unit radians",
	    "it is {\"angle_unit\": \"radians\"}" },
	{ SETTING, "infinite infinitefar", "projection far infinity",
	    "it is {\"projection\": {\"far\": \"infinity\"}}" },

	/* members of a camera */
	{ WORD_MEMBER, "pos eyepoint viewpoint cop from", "eye camera",
	    "where the camera stands it is \"eye\" of \"camera\"" },
	{ WORD_MEMBER, "to lookto center", "at camera pick eye",
	    "where one looks it is \"at\" of \"camera\" or \"pick\", where the camera "
	    "stands \"eye\" of \"camera\"" },
	{ WORD_MEMBER, "target", "center window",
	    "of a window it is \"center\" of \"window\"" },
	{ WORD_MEMBER, "vrp prp", "eye camera",
	    "the centre of projection is \"eye\" of \"camera\"" },
	{ WORD_MEMBER, "vpn", "gaze camera",
	    "it points to the eye; its opposite is \"gaze\" of \"camera\"" },
	{ WORD_MEMBER, "dop", "gaze camera",
	    "of an ortho it is \"gaze\" of \"camera\"" },
	{ WORD_MEMBER, "tvec translationvector", "translation camera",
	    "of world to view it is \"translation\" of \"camera\"" },
	{ WORD_MEMBER, "rodrigues rotationvector", "rvec camera",
	    "of world to view it is \"rvec\" of \"camera\"" },
	{ WORD_MEMBER, "quaternion quat q rotationquaternion localrotation",
	    "orientation camera world quaternion",
	    "x, y, z, w of view to world is \"orientation\" of \"camera\", as a step "
	    "{\"world\": [{\"quaternion\": [0,0,0,1]}]}" },
	{ WORD_MEMBER, "rotation", "orientation camera world quaternion",
	    "a quaternion x, y, z, w is as a step {\"world\": [{\"quaternion\": "
	    "[0,0,0,1]}]}, of view to world \"orientation\" of \"camera\"" },
	{ WORD_MEMBER, "qvec qw quaternionwxyz wxyz",
	    "convention opencv camera matrix quaternion_wxyz translate",
	    "of world to view, w first, it is {\"convention\": \"opencv\", \"camera\": "
	    "{\"matrix\": [{\"quaternion_wxyz\": [1,0,0,0]}, {\"translate\": "
	    "[0,0,5]}]}}" },
	{ WORD_MEMBER, "orientationwxyz",
	    "convention opencv camera pose quaternion_wxyz translate",
	    "of view to world, w first, it is {\"convention\": \"opencv\", \"camera\": "
	    "{\"pose\": [{\"quaternion_wxyz\": [1,0,0,0]}, {\"translate\": "
	    "[0,0,-5]}]}}" },
	{ WORD_MEMBER, "r t rotationmatrix",
	    "convention opencv camera rotation translation",
	    "of world to view it is as in {\"convention\": \"opencv\", \"camera\": "
	    "{\"rotation\": [[1,0,0],[0,1,0],[0,0,1]], \"translation\": [0,0,5]}}" },
	{ WORD_MEMBER,
	    "extrinsic extrinsics rt w2c tcw world2cam worldtocam "
	    "worldtocamera worldtocameramatrix viewmatrix modelviewmatrix "
	    "matrixworldinverse",
	    "matrix camera convention opencv",
	    "of world to view [R|t] is \"matrix\" of \"camera\", as {\"convention\": "
	    "\"opencv\", \"camera\": {\"matrix\": [[1,0,0,0],[0,1,0,0],[0,0,1,5]]}}" },
	{ WORD_MEMBER,
	    "c2w twc cam2world camtoworld cameratoworld transformmatrix matrixworld "
	    "localtoworldmatrix",
	    "pose camera", "of view to world it is \"pose\" of \"camera\"" },
	{ WORD_MEMBER, "view transform", "matrix camera pose",
	    "of world to view it is \"matrix\" of \"camera\", of view to world "
	    "\"pose\"" },
	{ WORD_MEMBER,
	    "euler eulerangles rotationeuler yaw pitch heading omega phi kappa azimuth",
	    "convention webgpu camera pose rotate_x rotate_y translate",
	    "angles are steps, as {\"convention\": \"webgpu\", \"camera\": {\"pose\": "
	    "[{\"rotate_x\": 10}, {\"rotate_y\": 30}, {\"translate\": [0,0,5]}]}}; "
	    "units, orders and signs differ" },

	/* of a projection */
	{ SETTING, "fov yfov vfov fovv verticalfov fieldofview cameraangley",
	    "fovy projection fovx",
	    "the vertical angle is \"fovy\" of \"projection\", the horizontal one "
	    "\"fovx\"" },
	{ WORD_MEMBER, "xfov hfov fovh horizontalfov cameraanglex", "fovx projection",
	    "it is \"fovx\" of \"projection\"" },
	{ WORD_MEMBER, "dfov diagonalfov fovd", "fovy projection",
	    "\"fovy\" of \"projection\" is 2 atan(tan(dfov / 2) height / hypot(width, "
	    "height))" },
	{ WORD_MEMBER, "angleleft angleright angleup angledown",
	    "angles projection angle_unit radians",
	    "they are \"angles\" of \"projection\", [left, right, bottom, top] in "
	    "{\"angle_unit\": \"radians\"} for OpenXR" },
	{ WORD_MEMBER, "orthographicsize", "height projection",
	    "\"height\" of \"projection\" is twice the orthographicSize" },
	{ WORD_MEMBER, "xmag ymag", "width height projection",
	    "\"width\" and \"height\" of \"projection\" are twice xmag and ymag" },
	{ WORD_MEMBER, "orthoscale", "width height projection",
	    "it is the greater of \"width\" and \"height\" of \"projection\"" },
	{ WORD_MEMBER, "ratio", "aspect projection",
	    "width over height is \"aspect\" of \"projection\"" },
	{ WORD_MEMBER, "hither yon nearfar", "near far projection",
	    "they are \"near\" and \"far\" of \"projection\"" },
	{ WORD_MEMBER, "shiftx shifty lensshift", "left right bottom top projection",
	    "give \"left\", \"right\", \"bottom\" and \"top\" of \"projection\"" },
	{ SETTING,
	    "focal focallength focallengthmm lens sensorwidth sensorheight sensorsize "
	    "filmgauge",
	    "projection persp edges_at width height intrinsics",
	    "in mm it is {\"projection\": {\"type\": \"persp\", \"edges_at\": 50, "
	    "\"width\": 36, \"height\": 24}}, in pixels \"intrinsics\" of "
	    "\"projection\"" },
	{ WORD_MEMBER, "fx fy cx cy flx fly skew principalpoint params",
	    "convention opencv projection persp intrinsics viewport width height",
	    "it is [fx, fy, cx, cy] as in {\"convention\": \"opencv\", \"projection\": "
	    "{\"type\": \"persp\", \"intrinsics\": [500,500,320,240]}, \"viewport\": "
	    "{\"width\": 640, \"height\": 480}}" },
	{ WORD_MEMBER,
	    "k p intrinsic intrinsicmatrix cameramatrix cameraintrinsic "
	    "cameraintrinsics p0 p1 p2 p3 prect00 prect01 prect02 prect03",
	    "intrinsics projection",
	    "K, or P as 3 rows of 4, is \"intrinsics\" of \"projection\"" },
	{ WORD_MEMBER, "projectionmatrix projmatrix proj", "matrix projection",
	    "of view to clip it is \"matrix\" of \"projection\" of type \"matrix\"" },
	{ WORD_MEMBER, "mvp vp viewproj viewprojection viewprojectionmatrix",
	    "matrix projection",
	    "without a camera it is \"matrix\" of \"projection\" of type \"matrix\"" },
	{ WORD_MEMBER, "perspective orthographic", "projection",
	    "it is the \"type\" of \"projection\"" },
	{ SETTING,
	    "distortion undistort distort distortioncoefficients distortioncoeffs "
	    "distortionmodel distcoeffs distcoef dist fisheye k1 k2 k3 k4 k5 k6",
	    NULL,
	    "lenses are not modelled; 'Points through a lens' in "
	    "'man projcalc-recipes' bends points" },

	/* of a world */
	{ WORD_MEMBER, "model modelmatrix", "world translate",
	    "it is {\"world\": [{\"translate\": [1,2,3]}]}, or a matrix in place of "
	    "steps" },
	{ WORD_MEMBER, "translation", "world translate translation camera",
	    "as a step it is {\"world\": [{\"translate\": [1,2,3]}]}, the t of [R|t] "
	    "\"translation\" of \"camera\"" },
	{ WORD_MEMBER, "trs localposition localscale",
	    "world node translation rotation scale",
	    "it is {\"world\": [{\"node\": {\"translation\": [1,2,3], \"rotation\": "
	    "[0,0,0,1], \"scale\": 2}}]}" },
	{ WORD_MEMBER, "axisangle angleaxis", "world rotate axis angle",
	    "it is {\"world\": [{\"rotate\": {\"axis\": [0,0,1], \"angle\": 90}}]}" },
	{ WORD_MEMBER, "r0rect rrect rrect00 tr trvelotocam trvelocam", "world matrix",
	    "steps chain matrices, as {\"world\": [{\"matrix\": "
	    "[[1,0,0,0],[0,1,0,0],[0,0,1,0]]}]}" },

	/* of rectangles */
	{ WORD_MEMBER, "size", "viewport width height projection",
	    "a picture's is {\"viewport\": {\"width\": 640, \"height\": 480}}, an "
	    "ortho's \"width\" and \"height\" of \"projection\"" },
	{ WORD_MEMBER, "imagesize resolution imageresolution windowsize screen image",
	    "viewport width height",
	    "the picture's size is {\"viewport\": {\"width\": 640, \"height\": 480}}" },
	{ WORD_MEMBER, "w h imagewidth imageheight pixelwidth pixelheight",
	    "width height viewport",
	    "of a picture it is \"width\" and \"height\" of \"viewport\"" },
	{ WORD_MEMBER, "l r b t xmin xmax ymin ymax right top",
	    "left right bottom top window projection x y width height viewport",
	    "edges are \"left\", \"right\", \"bottom\" and \"top\" of \"window\" or "
	    "\"projection\"; a viewport has \"x\", \"y\", \"width\" and \"height\" of "
	    "\"viewport\"" },
	{ WORD_MEMBER, "mindepth maxdepth", "min_z max_z viewport",
	    "they are \"min_z\" and \"max_z\" of \"viewport\"" },
	{ WORD_MEMBER, "depthrange zrange clipz ndcz",
	    "depth convention min_z max_z viewport",
	    "of ndc it is \"depth\" of \"convention\", of the device \"min_z\" and "
	    "\"max_z\" of \"viewport\"" },
	{ WORD_MEMBER, "origin", "origin device convention",
	    "it belongs in \"origin\" of \"device\" or \"convention\"" },
	{ WORD_MEMBER, "zoom", "zoom window fovy projection",
	    "only a window has \"zoom\" of \"window\"; in 3D give a smaller \"fovy\" "
	    "of \"projection\"" },
	{ WORD_MEMBER, "scale", "world scale zoom window",
	    "points are scaled by {\"world\": [{\"scale\": 2}]}, a window by \"zoom\" "
	    "of \"window\"" },
	{ WORD_MEMBER, "viewbox", "left right bottom top window",
	    "they are \"left\", \"right\", \"bottom\" and \"top\" of \"window\"" },
	{ WORD_MEMBER, "anchor", "about window", "it is \"about\" of \"window\"" },
	{ WORD_MEMBER, "objectfit preserveaspectratio", "adapt window",
	    "it is \"adapt\" of \"window\"" },
	{ WORD_MEMBER, "bbox boundingbox aabb", "min max bounds",
	    "they are \"min\" and \"max\" of \"bounds\"" },
	{ WORD_MEMBER, "padding border", "margin", "it is {\"margin\": 0.1}" },

	/* of whole documents */
	{ WORD_MEMBER, "binningx binningy roi", NULL,
	    "'A CameraInfo of ROS' in 'man projcalc-recipes' reads ROS's" },
	{ WORD_MEMBER, "asset accessors bufferviews", NULL,
	    "'A camera of glTF' in 'man projcalc-recipes' reads glTF" },
	{ WORD_MEMBER, "frames filepath aabbscale", NULL,
	    "'A frame of NeRF' in 'man projcalc-recipes' reads NeRF's" },
	{ WORD_MEMBER, "childframeid transforms", NULL,
	    "'Frames of ROS and tf2' in 'man projcalc-recipes' chains tf2's" },
	{ WORD_MEMBER, "sampletoken sensortoken calibratedsensortoken egoposetoken",
	    NULL, "'Sensors of nuScenes' in 'man projcalc-recipes' reads nuScenes'" },
};

enum { REMARKS = sizeof remarks / sizeof *remarks };

/* Skips _ and -, but not at the end of a word. */
static const char *skip_inner(const char *s)
{
	const char *next = s;

	while (*next == '_' || *next == '-')
		next++;
	return *next != '\0' ? next : s;
}

/* Does what word_equals does for name[0..n). */
static bool equals_part(const char *word, const char *name, size_t n)
{
	const char *const end = name + n;

	while (*word != '\0' && name < end &&
	    tolower((unsigned char)*word) == tolower((unsigned char)*name)) {
		word = skip_inner(word + 1);
		name = skip_inner(name + 1);
	}
	return *word == '\0' && name >= end;
}

bool word_equals(const char *word, const char *name)
{
	return equals_part(word, name, strlen(name));
}

bool word_is_one_of(const char *word, const char *words)
{
	for (; words != NULL && *words != '\0'; words += *words == ' ') {
		const size_t n = strcspn(words, " ");

		if (equals_part(word, words, n))
			return true;
		words += n;
	}
	return false;
}

int word_index(const char *word, const char *const *words, const char *const *aliases)
{
	for (int i = 0; words[i] != NULL; i++)
		if (word_equals(word, words[i]))
			return i;
	for (int i = 0; aliases != NULL && words[i] != NULL; i++)
		if (word_is_one_of(word, aliases[i]))
			return i;
	return -1;
}

static bool has_any(const char *list, const char *const *words)
{
	for (; words != NULL && *words != NULL; words++)
		if (word_is_one_of(*words, list))
			return true;
	return false;
}

const struct remark *word_remark(const char *word, enum word_place place,
    const char *const *names)
{
	const struct remark *other = NULL;

	for (int i = 0; i < REMARKS; i++) {
		const struct remark *r = &remarks[i];

		if ((r->places & place) == 0 || !word_is_one_of(word, r->words))
			continue;
		if (has_any(r->names, names))
			return r;
		if (other == NULL)
			other = r;
	}
	return place == WORD_VALUE ? NULL : other;
}

/* Room for a word of which the nearest is searched: longer ones have no near name. */
enum { WORD_ROOM = 64 };

/* Copies word[0..size), cut, in lower case and without inner _ and -. Returns the
 * length of the copy. */
static size_t reduce(char out[WORD_ROOM], const char *word, size_t size)
{
	const char *const end = word + size;
	size_t n = 0;

	for (; word < end && n < WORD_ROOM - 1; word = skip_inner(word + 1))
		out[n++] = (char)tolower((unsigned char)*word);
	out[n] = '\0';
	return n;
}

/* Returns whether at most n edits make b of a. */
static bool edits_reach(const char *a, const char *b, int n)
{
	for (; *a != '\0' && *a == *b; a++)
		b++;
	if (n == 0 || (*a == '\0' && *b == '\0'))
		return *a == *b;
	if ((*a != '\0' && edits_reach(a + 1, b, n - 1)) ||
	    (*b != '\0' && edits_reach(a, b + 1, n - 1)))
		return true;
	return *a != '\0' && *b != '\0' &&
	    (edits_reach(a + 1, b + 1, n - 1) ||
		(*a == b[1] && a[1] == *b && edits_reach(a + 2, b + 2, n - 1)));
}

/* Returns whether a word, reduced to `a`, is near by `edits` to one of `names`, which
 * have blanks between them; or, if `edits` is negative, whether one begins with the
 * other, by three letters or more. No name of fewer than `shortest` letters is near. */
static bool is_near(const char *a, const char *names, size_t shortest, int edits)
{
	char b[WORD_ROOM];

	for (; names != NULL && *names != '\0'; names += *names == ' ') {
		const size_t size = strcspn(names, " ");
		const size_t m = reduce(b, names, size), n = strlen(a),
			     least = n < m ? n : m;

		names += size;
		if (size >= shortest &&
		    (edits < 0 ? least > 2 && strncmp(a, b, least) == 0 :
				 edits_reach(a, b, edits)))
			return true;
	}
	return false;
}

const char *word_nearest(const char *word, const char *const *words,
    const char *const *aliases)
{
	enum { SHORTEST_ALIAS = 3 }; /* shorter ones are near to too much */
	char a[WORD_ROOM];
	const size_t n = reduce(a, word, strlen(word));
	const int most = n < 2 ? 0 : n < 6 ? 1 : n < 9 ? 2 : 3;

	for (int edits = 0; edits <= most + 1; edits++) {
		const int allowed = edits <= most ? edits : -1;

		for (int i = 0; words[i] != NULL; i++)
			if (is_near(a, words[i], 1, allowed))
				return words[i];
		for (int i = 0; aliases != NULL && words[i] != NULL; i++)
			if (is_near(a, aliases[i], SHORTEST_ALIAS, allowed))
				return words[i];
	}
	return NULL;
}

const char *word_remedy(char out[LIST_ROOM], const struct remark *remark,
    const char *near, const char *const *words, const char *quote)
{
	const int most = 12;
	char all[LIST_ROOM];
	int n = 0;

	while (words[n] != NULL)
		n++;
	*out = '\0';
	if (remark != NULL)
		snprintf(out, LIST_ROOM, "%s", remark->text);
	else if (near != NULL)
		snprintf(out, LIST_ROOM, "did you mean %s%s%s?", quote, near, quote);
	else if (n > 0 && n <= most)
		snprintf(out, LIST_ROOM, "there %s %.*s", n == 1 ? "is" : "are",
		    LIST_ROOM - (int)sizeof "there are ",
		    words_join(all, words, " and ", quote));
	return out;
}

const char *word_remedy_of_value(char out[LIST_ROOM], const char *word,
    const char *const *words, const char *const *aliases, const char *quote)
{
	return word_remedy(out, word_remark(word, WORD_VALUE, words),
	    word_nearest(word, words, aliases), words, quote);
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
