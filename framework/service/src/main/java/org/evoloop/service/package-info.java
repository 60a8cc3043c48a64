/**
 * Lets a converter run unattended: {@link org.evoloop.service.Service} goes on without a standard input, takes the
 * console's commands through a control socket and tells the service manager how it fares; {@link
 * org.evoloop.service.Ctl} is the socket's other end.
 *
 * <p>It uses the console and what that uses.
 */
@NullMarked
package org.evoloop.service;

import org.jspecify.annotations.NullMarked;
