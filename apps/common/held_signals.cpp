// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/held_signals.hpp"

namespace
{

// What a signal leaves for the end of HeldSignals; a handler reaches nothing else.
volatile std::sig_atomic_t held = 0;

void hold(int signal)
{
    held = signal;
}

} // namespace

HeldSignals::HeldSignals()
{
    held = 0;
    struct sigaction holding = {};
    holding.sa_handler = hold;
    sigemptyset(&holding.sa_mask);
    holding.sa_flags = SA_RESTART | SA_RESETHAND; // writing goes on; the second signal acts as it always does
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    {
        struct sigaction before = {};
        if (sigaction(signal, nullptr, &before) != 0 || before.sa_handler == SIG_IGN)
            continue;
        if (sigaction(signal, &holding, nullptr) == 0)
            actions_.push_back({signal, before});
    }
}

HeldSignals::~HeldSignals()
{
    for (const Action& action : actions_)
        sigaction(action.signal, &action.before, nullptr);
    if (held != 0)
        std::raise(held);
}

bool HeldSignals::asked() const
{
    return held != 0;
}
