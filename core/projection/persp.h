/* SPDX-License-Identifier: MIT */
/* Perspectives about the gaze, whose only numbers are a cross-section and planes. */
#pragma once

#include "type.h"

bool persp_check(const struct projection *, struct refusals *);
bool persp_check_map(const struct projection *, bool inverse, struct refusals *);
bool persp_map(const struct projection *, const struct convention *, bool inverse,
    struct map *, struct refusals *);
