package org.evoloop.xmi.astah;

import java.util.HashMap;
import java.util.Map;

/**
 * What the machines of a file need to know about each other.
 *
 * @param diagramNames by machine id
 * @param eventNames by event id
 * @param machines by id
 */
record AstahFile(
        Map<String, String> diagramNames,
        Map<String, String> eventNames,
        Map<String, AstahUnmarshaller.Result> machines) {
    AstahFile() {
        this(new HashMap<>(), new HashMap<>(), new HashMap<>());
    }
}
