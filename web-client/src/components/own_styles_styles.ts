import { css } from 'lit';

export const own_styles_styles = css`
  :host {
    display: block;
    margin-top: 18px;
  }
  h2 {
    margin: 0 2px 8px;
    font-size: 14px;
    font-weight: 600;
  }
  p {
    margin: 0 2px;
  }
  ul {
    display: grid;
    gap: 6px;
  }
  li {
    display: grid;
    grid-template-columns: 84px minmax(0, 1fr) auto auto;
    align-items: center;
    gap: 4px;
    border: 1px solid var(--line);
    border-radius: var(--radius);
    background: var(--surface-raised);
    overflow: hidden;
  }
  li.worn {
    border-color: var(--accent);
    box-shadow: 0 0 0 1px var(--accent);
  }
  .apply {
    padding: 0;
    border: 0;
    background: transparent;
  }
  .apply:focus-visible {
    outline-offset: -2px;
  }
  input:not([type='file']) {
    min-width: 0;
    padding: 6px 8px;
    border: 1px solid transparent;
    border-radius: 7px;
    background: transparent;
    color: var(--text);
    font: inherit;
    font-size: 13px;
    text-overflow: ellipsis;
  }
  li input:hover,
  li input:focus {
    border-color: var(--line-strong);
    background: var(--surface);
  }
  form {
    display: flex;
    gap: 6px;
    margin: 10px 0 6px;
  }
  form input:not([type='file']) {
    flex: 1;
    border-color: var(--line-strong);
    background: var(--surface-raised);
  }
  form input::placeholder {
    color: var(--text-quiet);
  }
  .import {
    width: 100%;
  }
  @media (pointer: coarse) {
    input:not([type='file']) {
      min-height: 44px;
    }
  }
`;
