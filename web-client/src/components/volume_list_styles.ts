// The list of volumes: a card with a picture for each.
import { css } from 'lit';
import { card_look } from '../styles/card.ts';

export const volume_list_styles = css`
  ul {
    display: grid;
    gap: 8px;
  }
  .entry {
    position: relative;
    display: grid;
    grid-template-columns: 84px minmax(0, 1fr);
    gap: 0 12px;
    min-height: 63px;
    ${card_look}
  }
  .entry:hover {
    background: var(--surface-hover);
  }
  .entry[aria-current='true'] {
    border-color: var(--accent);
    box-shadow: inset 3px 0 0 var(--accent);
  }
  .texts {
    align-self: center;
    padding: 9px 12px 9px 0;
  }
  .picture {
    display: grid;
    align-items: center;
    height: 100%;
    background: var(--page);
    color: var(--line-strong);
  }
  /* As high as the texts beside it. */
  .picture cutaway-style-picture {
    height: 100%;
    aspect-ratio: auto;
  }
  .picture wa-icon {
    justify-self: center;
    font-size: 26px;
  }
  .picture[data-picture='waiting'] wa-icon {
    animation: wait 1.8s ease-in-out infinite;
  }
  @keyframes wait {
    50% {
      opacity: 0.35;
    }
  }
  .title {
    display: block;
    font-weight: 600;
    overflow-wrap: anywhere;
  }
  .progress {
    position: relative;
    display: flex;
    align-items: center;
    justify-content: space-between;
    padding-left: 12px;
    font-variant-numeric: tabular-nums;
  }
  .bar {
    position: absolute;
    left: 0;
    top: 1px;
    height: 3px;
    border-radius: 2px;
    background: var(--accent);
    transition: width 160ms;
  }
  .search {
    display: grid;
    gap: 8px;
    margin-bottom: 12px;
  }
  .search input {
    min-width: 0;
    padding: 8px 12px;
    border: 1px solid var(--line-strong);
    border-radius: 9px;
    background: var(--surface-raised);
    color: var(--text);
    font: inherit;
  }
  .search input::placeholder {
    color: var(--text-quiet);
  }
  .modalities {
    display: flex;
    flex-wrap: wrap;
    gap: 6px;
  }
  @media (pointer: coarse) {
    .search input {
      min-height: 44px;
    }
  }
  .warning {
    display: flex;
    gap: 6px;
    margin-top: 4px;
    color: var(--warning);
    font-size: 12px;
  }
  .warning wa-icon {
    flex: none;
    font-size: 14px;
    margin-top: 1px;
  }
  .scanning {
    margin-top: 12px;
  }
  details {
    margin-top: 18px;
  }
  summary {
    padding: 6px 0;
    color: var(--text-quiet);
    cursor: pointer;
  }
  .refused li {
    padding: 8px 12px;
    border-left: 2px solid var(--problem);
    background: var(--surface-raised);
    overflow-wrap: anywhere;
  }
  .refused ul {
    gap: 6px;
  }
`;
