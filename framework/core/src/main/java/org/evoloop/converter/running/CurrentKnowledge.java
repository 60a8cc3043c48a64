package org.evoloop.converter.running;

import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.attachment.Friends;
import org.evoloop.converter.attachment.KnowledgeAccess;
import org.evoloop.converter.binding.Bindings;

/**
 * The present knowledge of a converter: other knowledge takes over between two events.
 *
 * <p>Threading: thread-safe; while an event is in the loop it stays the same.
 */
public final class CurrentKnowledge {
    private volatile StateKnowledge knowledge;
    private volatile KnowledgeAccess access;

    /** @param first the knowledge with which it begins */
    public CurrentKnowledge(StateKnowledge first) {
        knowledge = first;
        access = Friends.KNOWLEDGE.of(first);
    }

    StateKnowledge get() {
        return knowledge;
    }

    /** What it knows beside the models. */
    KnowledgeAccess access() {
        return access;
    }

    void become(StateKnowledge next) {
        knowledge = next;
        access = Friends.KNOWLEDGE.of(next);
    }

    Bindings bindings() {
        return access.bindings();
    }
}
