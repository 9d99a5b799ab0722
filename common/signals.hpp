// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <csignal>
#include <string>

namespace dem {

/// Whether a signal is to be heeded: not after nohup, nor Ctrl-C in what a script started in the
/// background.
bool is_heeded(int signal);

/// From now on the signals by which persons, terminals and batch systems ask a program to end
/// (SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGUSR2, SIGXCPU) are only noted. Ctrl-C that is repeated
/// seconds later ends the program at once.
void note_stop_signals();

/// The number of the first of them that came, 0 so far.
const volatile std::sig_atomic_t& stop_signal();

/// Ends the program the way the signal would have ended it, but without a core file: a shell sees
/// 128 + signal, and leaves a loop after Ctrl-C.
[[noreturn]] void end_by_signal(int signal);

/// "SIGTERM".
std::string signal_name(int signal);

/// From now on a write beyond the limit on file sizes, or into a pipe that nobody reads any more,
/// fails with its reason, as on a full disk, instead of ending the program.
void survive_failing_writes();

/// Opens standard input, output and error where whoever started the program closed them: the next
/// files would take their numbers, and messages would be written into them.
void open_standard_streams();

}  // namespace dem
