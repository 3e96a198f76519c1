/* Bytes as text (RFC 4648). */
#ifndef SUPPORT_BASE64_H
#define SUPPORT_BASE64_H

#include <stddef.h>

/* To be freed; NULL: no memory. */
char *base64_of(const void *bytes, size_t size);

#endif
