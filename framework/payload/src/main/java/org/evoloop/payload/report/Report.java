package org.evoloop.payload.report;

/**
 * What has been reported from one source, such as a topic of a broker.
 *
 * <p>Threading: immutable.
 *
 * @param text what is reported
 * @param old whether it may have been reported long ago, so that it is no event
 * @since 0.1
 */
public record Report(String text, boolean old) {}
