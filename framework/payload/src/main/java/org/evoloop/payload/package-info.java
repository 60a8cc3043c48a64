/**
 * What the messages of a controller or a device mean: {@link org.evoloop.payload.Meanings} of received ones, and {@link
 * org.evoloop.payload.Template} of those to be sent. A message may be a line, an MQTT payload or the body of an answer.
 *
 * <p>It uses the core and Jackson.
 */
@NullMarked
package org.evoloop.payload;

import org.jspecify.annotations.NullMarked;
