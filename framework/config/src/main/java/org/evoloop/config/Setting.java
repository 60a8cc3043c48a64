package org.evoloop.config;

import java.util.List;

/**
 * The given values of an option, as text and as read.
 *
 * @param origin the origin of the first value
 */
record Setting(Origin origin, List<String> texts, List<Object> values) {}
