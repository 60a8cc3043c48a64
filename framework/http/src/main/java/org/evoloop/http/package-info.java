/**
 * HTTP: {@link org.evoloop.http.HttpMonitor} turns requests into events, {@link org.evoloop.http.HttpExecute} turns
 * events into requests.
 *
 * <p>It uses the core and the JDK's server. Requests are sent over plain sockets, since the JDK's clients repeat a GET
 * that was not answered, and many devices treat a GET as a command.
 */
@NullMarked
package org.evoloop.http;

import org.jspecify.annotations.NullMarked;
