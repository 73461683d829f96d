// Waiting for the device, with an end.
#pragma once

namespace dioptre
{

// Returns when the device has done all that it was asked for. Throws retry where it was lost, or where a
// signal came meanwhile (see Interruption), and badInput after `limit_s`, with what an endless shader is
// likely to be mended by; after a signal or the limit the process ends soon, even where the device holds the
// end of its context.
void waitForDevice(double limit_s);

} // namespace dioptre
