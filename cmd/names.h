/* The names, on the command line and in what is printed, of precisions and
 * spaces: each list in the order of its enum; NULL ends it. */
#ifndef NAMES_H
#define NAMES_H

extern const char *const precision_names[], *const space_names[];

#endif
