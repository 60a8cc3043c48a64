/**
 * The console of a converter: a line of text is a command, typed by a person or piped in by a program. An application
 * adds commands for its device to those that every converter has, see {@link org.evoloop.console.Console}.
 *
 * <p>This package may use {@code org.evoloop.converter}, what that uses, and {@code org.evoloop.payload}. JLine edits lines on a terminal if it is on
 * the class path; only {@code TerminalIo} knows it.
 */
@NullMarked
package org.evoloop.console;

import org.jspecify.annotations.NullMarked;
