/* What stands around declarations, so that C++ calls their functions as C does. */
#ifndef SUREHIT_LINKAGE_H
#define SUREHIT_LINKAGE_H

#ifdef __cplusplus
#define SURE_C_BEGIN extern "C" {
#define SURE_C_END }
#else
#define SURE_C_BEGIN
#define SURE_C_END
#endif

#endif
