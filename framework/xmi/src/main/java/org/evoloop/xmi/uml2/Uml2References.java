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
    private final Map<Path, Uml2Document> documents = new HashMap<>();

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
            } else if (!Uml2Element.isProperty(child)) {
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
                    owner.place(),
                    owner.type() + " " + owner.label() + " has " + found.size() + " elements " + role + "; keep one");
        }
        return found.stream().findFirst();
    }

    private Optional<Uml2Element> byId(Uml2Element owner, String role, String id) {
        Optional<Uml2Element> found = owner.document().find(id);
        if (found.isEmpty()) {
            problems.add(
                    owner.place(),
                    role + " of " + owner.type() + " " + owner.label() + " refers to the unknown id "
                            + Problems.quote(id) + "; export the model again, or correct the id");
        } else if (owner.document().isAmbiguous(id)) {
            problems.add(
                    owner.place(),
                    role + " of " + owner.type() + " " + owner.label() + " refers to the id " + Problems.quote(id)
                            + ", which several elements have; give each an id of its own");
            return Optional.empty();
        }
        return found;
    }

    private Optional<Uml2Element> byHref(Uml2Element owner, XmlNode reference) {
        String href = reference.attribute("href");
        int hash = href.lastIndexOf('#');
        String wrong = ", which names no file; correct the reference";
        if (hash > 0) {
            try {
                Optional<Uml2Element> found =
                        document(owner.document(), href.substring(0, hash)).find(href.substring(hash + 1));
                if (found.isPresent()) {
                    return found;
                }
                wrong =
                        ", which holds no such element of a state machine; correct the reference, or draw the element in"
                                + " this model";
            } catch (ModelException unreadable) {
                wrong = ": " + unreadable.getMessage();
            }
        }
        problems.add(
                owner.place(reference),
                reference.name() + " of " + owner.type() + " " + owner.label() + " refers to another file, "
                        + Problems.quote(href) + wrong);
        return Optional.empty();
    }

    /** @throws ModelException if the file cannot be read; the message names it */
    private Uml2Document document(Uml2Document home, String href) {
        Path file = resolve(home, href);
        Path path = file.toAbsolutePath();
        if (href.startsWith("/") || !Files.isRegularFile(path)) {
            throw new ModelException(file + ": is not found from " + home.file()
                    + "; put that file where the reference expects it, or draw the element in this model");
        }
        if (!documents.containsKey(path) && documents.size() == MAX_FILES) {
            throw new ModelException(
                    file + ": is one of more than " + MAX_FILES + " files; put the elements into fewer files");
        }
        return documents.computeIfAbsent(path, any -> read(file));
    }

    private static Path resolve(Uml2Document home, String href) {
        try {
            return Path.of(home.file())
                    .resolveSibling(URLDecoder.decode(href, StandardCharsets.UTF_8))
                    .normalize();
        } catch (IllegalArgumentException noPath) {
            throw new ModelException(href + ": is not the path of a file; correct the reference", noPath);
        }
    }

    private static Uml2Document read(Path path) {
        try (XmiStream stream = XmiStream.open(path)) {
            XmiHead head = XmiHead.read(stream);
            if (!new Uml2Dialect().recognises(head)) {
                throw stream.refuse("found " + head + ", which is not UML 2", "refer to a file of UML 2");
            }
            return Uml2Document.read(head, stream, true);
        }
    }
}
