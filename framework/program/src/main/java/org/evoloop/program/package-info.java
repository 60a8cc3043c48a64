/**
 * Makes a converter into a program. {@link org.evoloop.program.Program} is told its name, options, models and parts,
 * and runs it with the console and all that its user asks for by an option: control socket, journal, page, metrics,
 * MQTT. What is not asked for is not started.
 *
 * <p>It uses all of the framework but the connections to devices; nothing but programs uses it.
 */
@NullMarked
package org.evoloop.program;

import org.jspecify.annotations.NullMarked;
