// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_HELD_SIGNALS_HPP
#define GCPW_APPS_HELD_SIGNALS_HPP

#include <csignal>
#include <vector>

/** @brief Holds back, while it lives, the signals that ask a program to end: SIGINT, SIGTERM and SIGHUP, whichever thread they
reach.

For the moment in which a file is written beside the one that it replaces: nothing unfinished stays behind. Whoever asks twice
ends the program at once. One at a time. */
class HeldSignals
{
public:
    HeldSignals();
    /// Puts the signals' actions back and sends the one that was held, if any.
    ~HeldSignals();
    /// Whether one was held: the work may be given up, and what is unfinished removed.
    bool asked() const;
    HeldSignals(const HeldSignals&) = delete;
    HeldSignals& operator=(const HeldSignals&) = delete;

private:
    struct Action
    {
        int signal;
        struct sigaction before;
    };
    std::vector<Action> actions_;
};

#endif
