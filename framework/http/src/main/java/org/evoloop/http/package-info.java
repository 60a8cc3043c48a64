/**
 * HTTP: {@link org.evoloop.http.HttpMonitor} makes events of requests, {@link org.evoloop.http.HttpExecute} makes
 * requests of events.
 *
 * <p>It uses the core and the JDK's server. Requests are sent over plain sockets: the JDK's clients send a GET again
 * that has not been answered, and to many a device a GET is a command.
 */
@NullMarked
package org.evoloop.http;

import org.jspecify.annotations.NullMarked;
