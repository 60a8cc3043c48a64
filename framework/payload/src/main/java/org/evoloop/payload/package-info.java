/**
 * What the messages of a controller or a device mean: {@link org.evoloop.payload.Meanings} of received ones, and {@link
 * org.evoloop.payload.Template} of those to be sent. A message may be a line, an MQTT payload or the body of an answer.
 *
 * <p>{@link org.evoloop.payload.JsonObject} and {@link org.evoloop.payload.JsonRecord} write and read JSON for all modules that
 * need no more than objects of texts and numbers.
 *
 * <p>It uses the core and Jackson.
 */
@NullMarked
package org.evoloop.payload;

import org.jspecify.annotations.NullMarked;
