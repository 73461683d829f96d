// How this process gets its memory from the system.
#pragma once

namespace dioptre
{

// Keeps large blocks on the heap, and the heap on large pages where the system has them. Pictures pass
// through many buffers of some MiB each, the driver's among them; malloc would give every one back to the
// system and take it anew, and a page fault for every 4 KiB costs more than decoding and uploading. To be
// called first thing in main(), before there are threads; does nothing where the C library is not glibc.
void keepLargeBlocks();

} // namespace dioptre
