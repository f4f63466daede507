/* SPDX-License-Identifier: MIT */
/* How finely a depth buffer tells distances apart. */
#ifndef DEPTH_H
#define DEPTH_H

#include "../scene/scene.h"

enum buffer { BUFFER_UNORM16, BUFFER_UNORM24, BUFFER_FLOAT32, BUFFERS };

/* The least distance, in view units along the gaze, inward from the near and
 * from the far plane beyond which device z is stored differently, rounded to
 * nearest even after it was clamped to what the buffer holds; the correctly
 * rounded value of a polynomial quotient of the parameters. nan at infinity and
 * where the whole volume is stored alike. Without a viewport device z runs from
 * 0 to 1. Where planes of equal depth are not parallel to the projection plane
 * it holds on the projector through the middle of the device. reversed: the
 * near plane has the larger depth. The scene is not degenerate. */
void depth_steps(const struct scene *, bool reversed, double step[BUFFERS][2]);

#endif
