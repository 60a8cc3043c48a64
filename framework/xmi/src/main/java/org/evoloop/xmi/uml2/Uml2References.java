package org.evoloop.xmi.uml2;

import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.evoloop.statemachine.ModelException;
import org.evoloop.xmi.dialect.Problems;
import org.evoloop.xmi.dialect.XmiHead;
import org.evoloop.xmi.dialect.XmiStream;
import org.evoloop.xmi.dialect.XmlNode;

/**
 * Resolves references: attributes with ids, elements with {@code xmi:idref}, and {@code href} to other files, relative
 * to the file being read.
 */
final class Uml2References {
    private static final int MAX_FILES = 50;

    private final Problems problems;
    private final Map<Path, Optional<Uml2Document>> documents = new HashMap<>();

    Uml2References(Problems problems) {
        this.problems = problems;
    }

    /** The elements with this role in {@code owner}, inside it or by reference; reports unknown references. */
    List<Uml2Element> all(Uml2Element owner, String role) {
        List<Uml2Element> found = new ArrayList<>();
        String ids = owner.attribute(role).strip();
        if (!ids.isEmpty()) {
            for (String id : ids.split("\\s+", -1)) {
                byId(owner, role, id).ifPresent(found::add);
            }
        }
        found.addAll(inside(owner, role));
        return withoutRepetition(found);
    }

    /** The same, without the elements that an attribute refers to. */
    List<Uml2Element> inside(Uml2Element owner, String role) {
        List<Uml2Element> found = new ArrayList<>();
        for (XmlNode child : owner.node().children(role)) {
            if (!child.attribute("xmi:idref").isEmpty()) {
                byId(owner, role, child.attribute("xmi:idref")).ifPresent(found::add);
            } else if (!child.attribute("href").isEmpty()) {
                byHref(owner, child).ifPresent(found::add);
            } else {
                found.add(new Uml2Element(child, owner.document()));
            }
        }
        return found;
    }

    /** Visual Paradigm repeats an element's contents as references. */
    private static List<Uml2Element> withoutRepetition(List<Uml2Element> found) {
        Set<String> ids = new HashSet<>();
        found.removeIf(element -> !element.id().isEmpty() && !ids.add(element.id()));
        return found;
    }

    /** The only element in this role; reports a problem if there are several. */
    Optional<Uml2Element> one(Uml2Element owner, String role) {
        List<Uml2Element> found = all(owner, role);
        if (found.size() > 1) {
            problems.add(
                    owner.line(),
                    owner.type() + " " + owner.label() + " has " + found.size() + " elements " + role + "; keep one");
        }
        return found.stream().findFirst();
    }

    private Optional<Uml2Element> byId(Uml2Element owner, String role, String id) {
        Optional<Uml2Element> found = owner.document().find(id);
        if (found.isEmpty()) {
            problems.add(
                    owner.line(),
                    role + " of " + owner.type() + " " + owner.label() + " refers to the unknown id "
                            + Problems.quote(id) + "; export the model again, or correct the id");
        } else if (owner.document().isAmbiguous(id)) {
            problems.add(
                    owner.line(),
                    role + " of " + owner.type() + " " + owner.label() + " refers to the id " + Problems.quote(id)
                            + ", which several elements have; give each an id of its own");
            return Optional.empty();
        }
        return found;
    }

    private Optional<Uml2Element> byHref(Uml2Element owner, XmlNode reference) {
        String href = reference.attribute("href");
        int hash = href.lastIndexOf('#');
        Optional<Uml2Element> found = Optional.empty();
        String reason = "names no file";
        if (hash > 0) {
            try {
                found = document(owner.document(), href.substring(0, hash))
                        .flatMap(document -> document.find(href.substring(hash + 1)));
                reason = "holds no such element of a state machine";
            } catch (ModelException unreadable) {
                reason = String.valueOf(unreadable.getMessage());
            }
        }
        if (found.isEmpty()) {
            problems.add(
                    reference.line(),
                    reference.name() + " of " + owner.type() + " " + owner.label() + " refers to another file, "
                            + Problems.quote(href) + ", which " + reason
                            + "; put that file where the reference expects it, or draw the element in this model");
        }
        return found;
    }

    /** @throws ModelException if the file cannot be read */
    private Optional<Uml2Document> document(Uml2Document home, String href) {
        try {
            Path file = Path.of(home.file()).toAbsolutePath().normalize();
            Path path = file.resolveSibling(URLDecoder.decode(href, StandardCharsets.UTF_8))
                    .normalize();
            if (href.startsWith("/") || !Files.isRegularFile(path)) {
                throw new ModelException("is not found from " + home.file());
            }
            if (!documents.containsKey(path) && documents.size() < MAX_FILES) {
                documents.put(path, read(path));
            }
            return documents.getOrDefault(path, Optional.empty());
        } catch (IllegalArgumentException noPath) {
            throw new ModelException("is not the path of a file", noPath);
        }
    }

    private static Optional<Uml2Document> read(Path path) {
        try (XmiStream stream = XmiStream.open(path)) {
            XmiHead head = XmiHead.read(stream);
            return new Uml2Dialect().recognises(head) ? Optional.of(Uml2Document.read(head, stream)) : Optional.empty();
        }
    }
}
