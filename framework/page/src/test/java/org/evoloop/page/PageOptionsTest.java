package org.evoloop.page;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Map;
import org.evoloop.config.Settings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class PageOptionsTest {
    @ParameterizedTest
    @CsvSource({"8080,127.0.0.1,8080", "0.0.0.0:80,0.0.0.0,80", "[::1]:1,[::1],1", "pi.local:65535,pi.local,65535"})
    void anAddressIsAPortOrAHostAndAPort(String given, String host, int port) {
        assertThat(PageOptions.at(given)).isEqualTo(new PageOptions(host, port, null));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"", "x", "65536", "-1", "8080x", ":8080", "a b:1", "http://x:1", "::1:80", "8080:", "999999"})
    void anythingElseIsRefusedWithAnExample(String given) {
        assertThatThrownBy(() -> PageOptions.at(given))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("192.168.1.5:8080")
                .hasMessageContaining("'" + given + "'");
    }

    @Test
    void aProgramIsGivenTheAddressOfItsPage() {
        Settings settings = PageOptions.OPTIONS.read(List.of("--page", "8080"), Map.of());
        assertThat(PageOptions.of(settings).port()).isEqualTo(8080);
        assertThat(PageOptions.of(PageOptions.OPTIONS.read(List.of(), Map.of())).isOn())
                .isFalse();
    }
}
