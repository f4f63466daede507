#include "format.h"

const char *const format_names[] = { "text", "csv", "json", "f64", "f32",
	NULL };

bool is_binary(enum format f)
{
	return f == FORMAT_F64 || f == FORMAT_F32;
}

size_t point_size(enum format f, int coordinates)
{
	return (size_t)coordinates *
	    (f == FORMAT_F64 ? sizeof(double) : sizeof(float));
}
