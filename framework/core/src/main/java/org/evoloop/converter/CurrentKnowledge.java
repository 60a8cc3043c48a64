package org.evoloop.converter;

/**
 * The present knowledge of a converter: other knowledge takes over between two events.
 *
 * <p>Threading: thread-safe; while an event is in the loop it stays the same.
 */
final class CurrentKnowledge {
    private volatile StateKnowledge knowledge;

    CurrentKnowledge(StateKnowledge first) {
        knowledge = first;
    }

    StateKnowledge get() {
        return knowledge;
    }

    void become(StateKnowledge next) {
        knowledge = next;
    }

    Bindings bindings() {
        return knowledge.bindings();
    }
}
