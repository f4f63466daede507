/* The members of a scene: what each may be. */
#ifndef MEMBERS_H
#define MEMBERS_H

#include "document.h"
#include "readers.h"

extern const struct member camera_members[], projection_members[],
    viewport_members[], window_members[], device_members[], bounds_members[],
    pick_members[];

/* Words of these members, in the order of their enums; NULL ends each. Types
 * are counted from PROJECTION_PERSP, kinds from OBLIQUE_CAVALIER. */
extern const char *const projection_types[], *const oblique_kinds[],
						 *const adapt_names[];

/* Returns whether the camera says where its eye is, as a matrix does too. */
bool read_camera(const struct value *, struct camera *);
void read_viewport(const struct value *, struct viewport *);
void read_window(const struct value *, struct window *);
void read_device(const struct value *, struct device *);
void read_bounds(const struct value *, struct bounds *);
void read_pick(const struct value *, struct pick *);

/* implied is the type that the command implies and demands, or PROJECTION_NONE;
 * viewport, from which an aspect is taken, is NULL where there is none. */
void read_projection(const struct value *, int implied,
    const struct viewport *viewport, struct projection *);

#endif
