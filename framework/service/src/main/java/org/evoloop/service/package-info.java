/**
 * Runs a converter unattended: {@link org.evoloop.service.Service} continues without standard input, accepts the
 * console's commands through a control socket, and reports its status to the service manager. {@link
 * org.evoloop.service.Ctl} is the client of the socket.
 *
 * <p>It uses the console and what that uses.
 */
@NullMarked
package org.evoloop.service;

import org.jspecify.annotations.NullMarked;
